using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class Selection
{
    public static Object activeObject { get; set; }
    public static GameObject activeGameObject
    {
        get => activeObject as GameObject;
        set => activeObject = value;
    }
}
