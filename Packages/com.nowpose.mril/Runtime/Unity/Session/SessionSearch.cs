using UnityEngine;

namespace Nowpose.Unity.Session
{
    static class SessionSearch
    {
        // It keeps nothing: one serves all.
        static readonly IHeadsetClock DeviceClock = new StopwatchHeadsetClock();

        /// <returns>The assigned one, else the one on the component's object or above it; null where there is none.</returns>
        public static MrilSession SessionOr(this Component component, MrilSession assigned) =>
            assigned != null ? assigned : component.GetComponentInParent<MrilSession>();

        /// <returns>The session's headset clock; the device's own where there is no session, or it was destroyed.</returns>
        public static IHeadsetClock ClockOrDevices(this MrilSession session) => session != null ? session.HeadsetClock : DeviceClock;
    }
}
