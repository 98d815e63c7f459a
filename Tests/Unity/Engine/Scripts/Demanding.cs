using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

[RequireComponent(typeof(TextMesh), typeof(MeshRenderer))]
[DisallowMultipleComponent]
sealed class Demanding : MonoBehaviour
{
}
