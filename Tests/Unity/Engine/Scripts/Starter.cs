using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>A script that has Start but no frame message.</summary>
sealed class Starter : MonoBehaviour
{
    void Start() => Journal.Note($"{name}.Start");
}
