using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

abstract class HiddenMessages : MonoBehaviour
{
    // Private, because Unity also calls private messages of a base class.
    void Update() => Journal.Note("base.Update");
}
