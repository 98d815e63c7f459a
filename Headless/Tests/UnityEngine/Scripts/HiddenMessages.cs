using UnityEngine;

namespace Nowpose.Headless.Tests.Engine;

abstract class HiddenMessages : MonoBehaviour
{
    // Private in a base class: Unity calls it all the same.
    void Update() => Journal.Note("base.Update");
}
