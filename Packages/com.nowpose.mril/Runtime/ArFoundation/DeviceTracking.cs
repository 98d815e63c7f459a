using Nowpose.Anchoring;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    static class DeviceTracking
    {
        public static MarkerTracking OfMarker(this TrackingState state)
        {
            switch (state)
            {
                case TrackingState.Tracking: return MarkerTracking.Tracking;
                case TrackingState.Limited: return MarkerTracking.Limited;
                default: return MarkerTracking.None;
            }
        }
    }
}
