namespace UnityEngine.XR.ARSubsystems;

public struct XRReferenceImage
{
    internal XRReferenceImage(string name) => this.name = name;

    public string name { get; }
}
