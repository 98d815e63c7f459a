using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    static class SessionSearch
    {
        // Stateless, so one instance is shared.
        static readonly IHeadsetClock DeviceClock = new StopwatchHeadsetClock();

        /// <returns>The assigned session, else the one on the component's object or above it; null if there is none.</returns>
        public static MrilSession SessionOr(this Component component, MrilSession assigned) =>
            assigned != null ? assigned : component.GetComponentInParent<MrilSession>();

        /// <summary>Gets the session of a component that needs one. Warns if there is none.</summary>
        /// <param name="kind">Kind of the component, for example "status panel".</param>
        public static MrilSession RequiredSession(this Component component, MrilSession assigned, string kind)
        {
            var session = component.SessionOr(assigned);
            if (session == null)
                ConsoleLog.Warn(component, ComponentMessages.ComponentWithoutSession(kind, component.name));
            return session;
        }

        /// <returns>The session's headset clock; the device's own without a session, or if it was destroyed.</returns>
        public static IHeadsetClock ClockOrDevices(this MrilSession session) => session != null ? session.HeadsetClock : DeviceClock;
    }
}
