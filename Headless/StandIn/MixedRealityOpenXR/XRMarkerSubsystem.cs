using System.Collections.Generic;
using UnityEngine.SubsystemsImplementation;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR.ARSubsystems;

public class XRMarkerSubsystem : TrackingSubsystem<XRMarker, XRMarkerSubsystem, XRMarkerSubsystemDescriptor, XRMarkerSubsystem.Provider>
{
    /// <summary>Texts of the codes that the device has decoded.</summary>
    internal Dictionary<TrackableId, string> Texts { get; } = new();

    /// <summary>Number of requests for the text of a code.</summary>
    internal int TextsAsked { get; set; }

    public abstract class Provider : SubsystemProvider<XRMarkerSubsystem>
    {
    }
}
