using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

sealed class WithFixedUpdate : MonoBehaviour
{
    void FixedUpdate() => Journal.Note("FixedUpdate");
}
