using Nowpose.Anchoring;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>Creates the strings that the status panel shows about the robot's base.</summary>
    /// <remarks>Allocates only when the base is locked again or its message changes. The strings for displacements are preallocated.</remarks>
    sealed class BaseTexts
    {
        static readonly NumberTexts Millimetres = new NumberTexts("", StatusMessages.OffsetSuffix, (1, 0, 0));

        LockReport _noted;
        string _note = "", _words, _fault;

        public string NoteOf(BaseAnchor anchor)
        {
            var tracker = anchor.Tracker;
            if (tracker == null) return "";
            if (anchor.State == BaseAnchorState.Moved) return Millimetres.Of(1000 * Worst(tracker));
            if (anchor.State != BaseAnchorState.Locked) return "";
            if (tracker.Lock != _noted) _note = Note(tracker.Lock);
            _noted = tracker.Lock;
            return _note;
        }

        /// <summary>Returns the description of a problem with the base, with an instruction to the user; null without a problem.</summary>
        /// <param name="anchor">The anchor of the base; null if there is none.</param>
        public string FaultOf(BaseAnchor anchor)
        {
            if (anchor == null || (anchor.State == BaseAnchorState.Placed && anchor.Tracker?.RefusedPayload == null)) return null;
            if (anchor.State == BaseAnchorState.Locked && !IsWrong(anchor.Tracker)) return null;
            if (!ReferenceEquals(anchor.Words, _words)) _fault = "base: " + anchor.Words;
            _words = anchor.Words;
            return _fault;
        }

        /// <summary>Returns whether a locked base has something to report: a conflict, a problem, a correction or an unknown marker.</summary>
        public static bool IsWrong(BaseTracker tracker) => tracker != null
            && (tracker.Conflict != null || tracker.Problem != null || tracker.IsCorrected || tracker.RefusedPayload != null);

        static double Worst(BaseTracker tracker)
        {
            double worst = 0;
            for (var i = 0; i < tracker.Markers.Count; i++)
                if (tracker.Markers[i].HasMoved && tracker.Markers[i].DeviationMetres > worst) worst = tracker.Markers[i].DeviationMetres.Value;
            return worst;
        }

        static string Note(LockReport report) => report.Markers == 0
            ? StatusMessages.LockedByHand
            : StatusMessages.Spread(1000 * report.SpreadMetres, report.SpreadRadians * Mathf.Rad2Deg);
    }
}
