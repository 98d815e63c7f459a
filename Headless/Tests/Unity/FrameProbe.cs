using UnityEngine;

namespace Nowpose.Headless.Tests.Unity;

/// <summary>A user's script.</summary>
sealed class FrameProbe : MonoBehaviour
{
    public Action Updated { get; set; }
    public Action LateUpdated { get; set; }

    void Update() => Updated?.Invoke();
    void LateUpdate() => LateUpdated?.Invoke();
}
