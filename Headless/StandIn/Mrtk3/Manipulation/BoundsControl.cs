using UnityEngine;
using UnityEngine.XR.Interaction.Toolkit;

namespace MixedReality.Toolkit.SpatialManipulation;

/// <summary>Handles about an object; here a test pulls at them.</summary>
public class BoundsControl : MonoBehaviour
{
    public SelectEnterEvent ManipulationStarted { get; set; } = new();
    public SelectExitEvent ManipulationEnded { get; set; } = new();
}
