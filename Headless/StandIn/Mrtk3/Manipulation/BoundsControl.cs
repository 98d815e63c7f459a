using UnityEngine;
using UnityEngine.XR.Interaction.Toolkit;

namespace MixedReality.Toolkit.SpatialManipulation;

/// <summary>Handles around an object. Tests simulate their movement.</summary>
public class BoundsControl : MonoBehaviour
{
    public SelectEnterEvent ManipulationStarted { get; set; } = new();
    public SelectExitEvent ManipulationEnded { get; set; } = new();
}
