using UnityEngine.SubsystemsImplementation;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR.ARSubsystems;

public class XRMarkerSubsystem : TrackingSubsystem<XRMarker, XRMarkerSubsystem, XRMarkerSubsystemDescriptor, XRMarkerSubsystem.Provider>
{
    /// <summary>Contents of the codes that the device has decoded, by the ids of the trackables.</summary>
    internal Dictionary<TrackableId, string> Texts { get; } = new();

    /// <summary>Number of requests for the content of a code.</summary>
    internal int TextsAsked { get; set; }

    public abstract class Provider : SubsystemProvider<XRMarkerSubsystem>
    {
    }
}

public class XRMarkerSubsystemDescriptor : SubsystemDescriptorWithProvider<XRMarkerSubsystem, XRMarkerSubsystem.Provider>
{
}
