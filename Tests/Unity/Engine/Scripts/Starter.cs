using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Has no message for frames, so that Start shows for itself.</summary>
sealed class Starter : MonoBehaviour
{
    void Start() => Journal.Note($"{name}.Start");
}
