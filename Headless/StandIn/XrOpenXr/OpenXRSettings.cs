namespace UnityEngine.XR.OpenXR;

public class OpenXRSettings : ScriptableObject
{
    public enum DepthSubmissionMode
    {
        None,
        Depth16Bit,
        Depth24Bit,
    }

    public static OpenXRSettings Instance { get; internal set; }

    public DepthSubmissionMode depthSubmissionMode { get; set; }
}
