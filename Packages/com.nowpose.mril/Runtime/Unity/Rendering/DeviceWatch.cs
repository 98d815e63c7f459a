using System.Collections.Generic;
using Nowpose.Session;
using UnityEngine.XR;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Reports the conditions of this device to a session, when the session starts and again when the display starts to report its rate.
    /// </summary>
    sealed class DeviceWatch
    {
        /// <summary>
        /// FramesBetweenLooks: interval between checks, in frames. MaxLooks: maximum number of checks. The display starts some frames after the
        /// scene.
        /// </summary>
        const int FramesBetweenLooks = 60, MaxLooks = 10;

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
            if (_frames >= FramesBetweenLooks * MaxLooks || ++_frames % FramesBetweenLooks != 0) return;
            var hertz = ThisDevice.DisplayHz(_displays);
            if (hertz.HasValue && hertz != session.Conditions.DisplayHz) session.Conditions = ThisDevice.Conditions;
        }
    }
}
