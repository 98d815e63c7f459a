using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Has only Start and no frame message, so that Start is tested alone.</summary>
sealed class Starter : MonoBehaviour
{
    void Start() => Journal.Note($"{name}.Start");
}
