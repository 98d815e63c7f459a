using System.Collections.Generic;
using UnityEngine.SubsystemsImplementation;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR.ARSubsystems;

public class XRMarkerSubsystem : TrackingSubsystem<XRMarker, XRMarkerSubsystem, XRMarkerSubsystemDescriptor, XRMarkerSubsystem.Provider>
{
    /// <summary>Texts of the codes, once they are read.</summary>
    internal Dictionary<TrackableId, string> Texts { get; } = new();

    /// <summary>Number of requests for a text.</summary>
    internal int TextsAsked { get; set; }

    public abstract class Provider : SubsystemProvider<XRMarkerSubsystem>
    {
    }
}
