namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static int sceneCount => Scenes.Loaded.Count;

    public static Scene GetActiveScene() => new(Scenes.Active);

    static Scenes Scenes => World.Current.Scenes;
}
