using System.Collections.Generic;
using Nowpose.Session;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Reports the conditions of this device to a session, when the session starts and again when the display reports another rate.
    /// </summary>
    sealed class DeviceWatch
    {
        /// <summary>Interval between checks, in frames. The display starts after the scene, and an app or the user may change its rate.</summary>
        const int FramesBetweenLooks = 60;

        readonly List<XRDisplaySubsystem> _displays = new List<XRDisplaySubsystem>();
        int _frames;

        public void Begin(CompensationSession session)
        {
            _frames = 0;
            session.Conditions = ThisDevice.Conditions;
        }

        /// <summary>Checks the display rate at intervals. Call once per frame. Allocates only if the rate has changed.</summary>
        public void Follow(CompensationSession session)
        {
            if (++_frames < FramesBetweenLooks) return;
            _frames = 0;
            var hertz = ThisDevice.DisplayHz(_displays);
            if (hertz.HasValue && hertz != session.Conditions.DisplayHz) session.Conditions = ThisDevice.Conditions;
        }
    }
}
