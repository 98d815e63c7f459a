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

        /// <returns>The session's headset clock; the device's own without a session, or if it was destroyed.</returns>
        public static IHeadsetClock ClockOrDevices(this MrilSession session) => session != null ? session.HeadsetClock : DeviceClock;
    }
}
