using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>A script in place of a user's script. It calls delegates of the test.</summary>
sealed class FrameProbe : MonoBehaviour
{
    public Action Updated { get; set; }
    public Action LateUpdated { get; set; }

    void Update() => Updated?.Invoke();
    void LateUpdate() => LateUpdated?.Invoke();
}
