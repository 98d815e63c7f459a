using System.Collections.Generic;
using UnityEngine;
using UnityEngine.XR;

namespace Nowpose.Unity
{
    /// <summary>What a calibration holds for: the device and its display. Asked once, not in each frame.</summary>
    static class ThisDevice
    {
        /// <summary>The model, as its maker calls it.</summary>
        public static string Name => SystemInfo.deviceModel;

        /// <summary>Of the headset's display, hertz; NaN where none runs or it does not tell.</summary>
        public static double DisplayHz
        {
            get
            {
                var displays = new List<XRDisplaySubsystem>();
                SubsystemManager.GetSubsystems(displays);
                return displays.Count > 0 && displays[0].TryGetDisplayRefreshRate(out var hertz) && hertz >= 1 && hertz <= 1000
                    ? hertz : double.NaN;
            }
        }
    }
}
