namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static int sceneCount => Scenes.Loaded.Count;

    public static Scene GetActiveScene() => new(Scenes.Active);

    public static Scene GetSceneAt(int index) => new(Scenes.Loaded[index]);

    public static Scene CreateScene(string sceneName) => new(Scenes.Add(sceneName, ""));

    public static bool SetActiveScene(Scene scene)
    {
        if (!scene.IsValid()) return false;

        Scenes.Active = scene.Content;
        return true;
    }

    public static void MoveGameObjectToScene(GameObject go, Scene scene) => scene.Content.Take(go);

    static Scenes Scenes => World.Current.Scenes;
}
