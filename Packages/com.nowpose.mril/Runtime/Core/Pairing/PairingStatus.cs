using System;

namespace Nowpose.Pairing
{
    /// <summary>The text about the pairing for the wearer: the question, a problem, or the status of the cell in use. Collects the changes of a frame.</summary>
    sealed class PairingStatus
    {
        readonly Func<string> _question, _calm;
        HeadsetTime? _faultUntil;
        PairingChange _changes;

        /// <param name="question">Returns the question to the wearer; null if there is none.</param>
        /// <param name="calm">Returns the status while there is neither a question nor a problem.</param>
        public PairingStatus(Func<string> question, Func<string> calm)
        {
            (_question, _calm) = (question, calm);
            Words = calm();
        }

        /// <summary>The problem in one line; null if there is none.</summary>
        public string Problem { get; private set; }

        public string Words { get; private set; }

        /// <summary>Returns the changes since the last call.</summary>
        public PairingChange TakeChanges()
        {
            var changes = _changes;
            _changes = PairingChange.None;
            return changes;
        }

        public void Change(PairingChange change)
        {
            _changes |= change;
            SetWords(_question() ?? Problem ?? _calm());
        }

        public void SetWords(string words)
        {
            if (words == Words) return;
            Words = words;
            _changes |= PairingChange.Words;
        }

        /// <param name="until">Time until which the problem is shown; null until something else clears it.</param>
        public void Fail(string problem, HeadsetTime? until = null)
        {
            (Problem, _faultUntil) = (problem, until);
            Change(PairingChange.Problem);
        }

        /// <summary>Clears a problem whose time is over.</summary>
        public void Expire(HeadsetTime now)
        {
            if (now >= _faultUntil) ClearProblem();
        }

        public void ClearProblem()
        {
            // Keeps a problem that has not been reported yet.
            if (Problem == null || (_changes & PairingChange.Problem) != 0) return;
            (Problem, _faultUntil) = (null, null);
            Change(PairingChange.Words);
        }
    }
}
