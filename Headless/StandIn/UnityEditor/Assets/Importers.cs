using System.Reflection;
using UnityEditor.AssetImporters;

namespace UnityEditor;

/// <summary>Finds scripted importers by the file extensions that they declare, and runs them as Unity does.</summary>
static class Importers
{
    /// <summary>Returns the type of the importer for a file; null if no loaded assembly has one.</summary>
    internal static Type For(string path)
    {
        var extension = Path.GetExtension(path).TrimStart('.');
        return EditorAssemblies.Types
            .FirstOrDefault(t => t.GetCustomAttribute<ScriptedImporterAttribute>()?.fileExtensions.Contains(extension) == true);
    }

    internal static Imported Import(Type type, string path) => Import((ScriptedImporter)Activator.CreateInstance(type), path);

    /// <summary>Imports a file.</summary>
    /// <param name="importer">The importer with its import settings.</param>
    internal static Imported Import(ScriptedImporter importer, string path)
    {
        var context = new AssetImportContext(path);
        Project.InRoot(() =>
        {
            importer.OnImportAsset(context);
            return true;
        });
        context.CheckPaths();
        return new Imported(context);
    }

    /// <summary>Result of an import. Its objects are not in a scene.</summary>
    internal sealed class Imported
    {
        internal Imported(AssetImportContext context)
        {
            Context = context;
            var objects = new List<Object>();
            context.GetObjects(objects);
            foreach (var gameObject in objects.OfType<GameObject>())
            {
                gameObject.Content?.Remove(gameObject);
                gameObject.MoveTo(null);
            }
            Objects = objects.OrderBy(o => o == context.mainObject ? 0 : 1).ToArray();
        }

        internal AssetImportContext Context { get; }

        internal Object[] Objects { get; }
    }
}
