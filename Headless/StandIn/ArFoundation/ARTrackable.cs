namespace UnityEngine.XR.ARFoundation;

public abstract class ARTrackable : MonoBehaviour
{
}
