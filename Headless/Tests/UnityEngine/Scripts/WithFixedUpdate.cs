using UnityEngine;

namespace Nowpose.Headless.Tests.Engine;

sealed class WithFixedUpdate : MonoBehaviour
{
    void FixedUpdate() => Journal.Note("FixedUpdate");
}
