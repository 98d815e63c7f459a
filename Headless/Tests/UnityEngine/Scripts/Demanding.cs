using UnityEngine;

namespace Nowpose.Headless.Tests.Engine;

[RequireComponent(typeof(TextMesh), typeof(MeshRenderer))]
[DisallowMultipleComponent]
sealed class Demanding : MonoBehaviour
{
}
