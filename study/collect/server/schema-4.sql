-- The schema palpate, step 4: a reason counts once it is committed, so that it cannot be rolled back after reading; and operators
-- see no station of another site.

ALTER TABLE access ADD COLUMN written_by xid8 NOT NULL DEFAULT pg_current_xact_id();
ALTER TABLE access DROP CONSTRAINT access_reason_check;
ALTER TABLE access ADD CONSTRAINT a_reason_is_given CHECK (reason ~ '\S') NOT VALID;  -- older rows stay

-- The study that a ticket of unblind() is for. What a transaction or its savepoints wrote themselves may still be undone;
-- what others wrote is seen only after they committed it.
CREATE OR REPLACE FUNCTION opened(ticket bigint) RETURNS text
LANGUAGE plpgsql STABLE SET search_path = palpate, pg_temp AS $$
DECLARE
  found_study text;
BEGIN
  SELECT study INTO found_study FROM access
  WHERE id = ticket AND role = session_user AND at > now() - interval '1 day'
    AND written_by IS DISTINCT FROM pg_current_xact_id_if_assigned();
  IF NOT FOUND THEN
    RAISE EXCEPTION 'nobody gave a reason for this' USING ERRCODE = 'insufficient_privilege';
  END IF;
  RETURN found_study;
END $$;

ALTER TABLE station ENABLE ROW LEVEL SECURITY;
CREATE POLICY own_site ON station FOR SELECT TO palpate_operator USING (operates(site));
