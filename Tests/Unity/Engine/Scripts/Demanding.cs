using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

[RequireComponent(typeof(TextMesh), typeof(MeshRenderer))]
[DisallowMultipleComponent]
sealed class Demanding : MonoBehaviour
{
}
