using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

sealed class WithFixedUpdate : MonoBehaviour
{
    void FixedUpdate() => Journal.Note("FixedUpdate");
}
