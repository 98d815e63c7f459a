using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>A component with parts that a session moves or switches.</summary>
    interface IFollowsSession
    {
        /// <summary>The session that is assigned in the Inspector or by a script; null to use the session on the object or a parent.</summary>
        MrilSession AssignedSession { get; }
    }

    static class SessionSearch
    {
        // The clock has no state, so all callers can share one instance.
        static readonly IHeadsetClock DeviceClock = new StopwatchHeadsetClock();

        /// <summary>Returns the assigned session, or else the session on the component's object or a parent; null if there is none.</summary>
        public static MrilSession SessionOr(this Component component, MrilSession assigned) =>
            assigned != null ? assigned : component.GetComponentInParent<MrilSession>();

        /// <summary>
        /// Returns the assigned session, or else the session that is assigned to the object of the cell, the signal or the rig, because it also applies to their
        /// parts, or else the session on the component's object or a parent; null if there is none.
        /// </summary>
        /// <param name="rig">The rig of the parts; null if they have none.</param>
        public static MrilSession SessionOfParts(this Component component, MrilSession assigned, RobotRig rig)
        {
            if (assigned == null && component.TryGetComponent<IFollowsSession>(out var part)) assigned = part.AssignedSession;
            if (assigned == null && rig != null) assigned = rig.AssignedSession;
            return component.SessionOr(assigned);
        }

        /// <summary>Returns whether a component, which may be inactive, belongs to a session.</summary>
        /// <param name="assigned">The session that is assigned to the component; null to use the one on its object or a parent.</param>
        public static bool IsOf(this Component component, MrilSession assigned, MrilSession session) =>
            (assigned != null ? assigned : component.GetComponentInParent<MrilSession>(true)) == session;

        /// <summary>
        /// Returns whether an enabled component without an assigned session is below another session than the one that it uses, because the
        /// component or one of its parents has got a new parent.
        /// </summary>
        /// <param name="used">The session that the component uses; null if it uses none.</param>
        public static bool IsBelowAnotherSession(this MonoBehaviour component, MrilSession assigned, MrilSession used) =>
            component.isActiveAndEnabled && assigned == null && component.SessionOr(null) != used;

        /// <summary>
        /// Returns whether an enabled component without an assigned rig is below another rig than the one that it uses, because the component or one
        /// of its parents has got a new parent.
        /// </summary>
        /// <param name="used">The rig that the component uses; null if it uses none.</param>
        public static bool IsBelowAnotherRig(this MonoBehaviour component, RobotRig assigned, RobotRig used) =>
            component.isActiveAndEnabled && assigned == null && component.GetComponentInParent<RobotRig>() != used;

        /// <summary>Returns the same session as <see cref="SessionOr"/>, for a component that needs one. Logs a warning if there is none.</summary>
        /// <param name="kind">Kind of the component, for example "status panel".</param>
        public static MrilSession RequiredSession(this Component component, MrilSession assigned, string kind)
        {
            var session = component.SessionOr(assigned);
            if (session == null)
                ConsoleLog.Warn(component, ComponentMessages.ComponentWithoutSession(kind, component.name));
            return session;
        }

        /// <summary>
        /// Returns the same session as <see cref="SessionOr"/>, for a source of markers. Logs a warning if no base anchor searches where the source is.
        /// </summary>
        /// <param name="kind">Kind of the source, for example "QR markers".</param>
        public static MrilSession SessionOfSource(this Component source, MrilSession assigned, string kind)
        {
            // A base anchor without a session searches below the root of its hierarchy.
            if (source.SessionOr(null) == null && source.transform.root.GetComponentInChildren<BaseAnchor>(true) == null)
                ConsoleLog.Warn(source, ComponentMessages.Of(kind, source.name, ComponentMessages.SourceOutsideSession));
            return source.SessionOr(assigned);
        }

        /// <summary>Returns the headset clock of the session, or a stopwatch if the session is null or destroyed.</summary>
        public static IHeadsetClock ClockOrDevices(this MrilSession session) => session != null ? session.HeadsetClock : DeviceClock;
    }
}
