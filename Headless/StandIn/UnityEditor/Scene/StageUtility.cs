using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>Does nothing: there is only the main stage, which contains everything.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject) { }
}
