using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>A script as a user would write it.</summary>
sealed class FrameProbe : MonoBehaviour
{
    public Action Updated { get; set; }
    public Action LateUpdated { get; set; }

    void Update() => Updated?.Invoke();
    void LateUpdate() => LateUpdated?.Invoke();
}
