namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>Does nothing, because the stand-in has only the main stage, which contains all objects.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject) { }
}
