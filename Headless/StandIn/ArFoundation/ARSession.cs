using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

[DisallowMultipleComponent]
public sealed class ARSession : MonoBehaviour
{
    public static ARSessionState state => (ARSessionState)(ArDevice.Current?.SessionState ?? 0);
}

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
