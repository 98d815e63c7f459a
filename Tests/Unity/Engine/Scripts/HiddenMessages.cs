using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

abstract class HiddenMessages : MonoBehaviour
{
    // Private in a base class: Unity calls it all the same.
    void Update() => Journal.Note("base.Update");
}
