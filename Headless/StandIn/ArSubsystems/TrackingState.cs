namespace UnityEngine.XR.ARSubsystems;

public enum TrackingState
{
    None,
    Limited,
    Tracking,
}
