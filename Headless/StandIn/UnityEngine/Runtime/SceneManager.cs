namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static int sceneCountInBuildSettings => World.Current.Scenes.BuildList.Count;

    public static Scene GetActiveScene() => new(World.Current.Scenes.Active);
}
