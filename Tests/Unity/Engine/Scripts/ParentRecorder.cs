using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>A script that notes changes of its direct or indirect parent.</summary>
class ParentRecorder : MonoBehaviour
{
    void OnTransformParentChanged() => Journal.Note(name + ".OnTransformParentChanged");
}
