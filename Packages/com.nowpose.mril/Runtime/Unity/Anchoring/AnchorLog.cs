using Nowpose.Anchoring;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>
    /// Logs the states of a base anchor, and each problem, conflict, correction and unknown marker once: as a warning if the user must act, otherwise as
    /// information.
    /// </summary>
    sealed class AnchorLog
    {
        BaseAnchorState _state;
        string _problem, _refused;
        MarkerConflict _conflict;
        bool _isCorrected;

        /// <param name="tracker">Tracker of the anchor; null without one.</param>
        /// <param name="isQuiet">
        /// Whether nothing is logged, because an invalid field was already logged as an error, or because the component is disabled by a user or at the end of
        /// the scene.
        /// </param>
        public void Log(Object anchor, BaseTracker tracker, BaseAnchorState state, string words, bool isQuiet)
        {
            var (isWrong, isNew) = (HasNewProblem(tracker), state != _state);
            _state = state;
            if (isQuiet || !(isNew || isWrong)) return;
            var message = "base anchor '" + anchor.name + "': " + words;
            if (state == BaseAnchorState.Moved || state == BaseAnchorState.Lost || isWrong) ConsoleLog.Warn(anchor, message);
            else ConsoleLog.Info(anchor, message);
        }

        bool HasNewProblem(BaseTracker tracker)
        {
            if (tracker == null) return false;
            var (problem, conflict, isCorrected, refused) = (tracker.Problem, tracker.Conflict, tracker.IsCorrected, tracker.RefusedPayload);
            var isNew = (problem != null && problem != _problem) || (conflict != null && !conflict.IsOf(_conflict))
                || (isCorrected && !_isCorrected) || (refused != null && refused != _refused);
            (_problem, _conflict, _isCorrected, _refused) = (problem, conflict, isCorrected, refused);
            return isNew;
        }
    }
}
