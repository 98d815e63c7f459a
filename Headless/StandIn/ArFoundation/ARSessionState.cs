namespace UnityEngine.XR.ARFoundation;

public enum ARSessionState
{
    None,
    Unsupported,
    CheckingAvailability,
    NeedsInstall,
    Installing,
    Ready,
    SessionInitializing,
    SessionTracking,
}
