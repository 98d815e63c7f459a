using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>Only the main stage is there, in which everything is anyway.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject) { }
}
