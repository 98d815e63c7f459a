using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>A user's script.</summary>
sealed class FrameProbe : MonoBehaviour
{
    public Action Updated { get; set; }
    public Action LateUpdated { get; set; }

    void Update() => Updated?.Invoke();
    void LateUpdate() => LateUpdated?.Invoke();
}
