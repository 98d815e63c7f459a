using System.Linq;
using Nowpose.Unity;
using Nowpose.Unity.Cell;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Adds ghosts of objects: objects that show the newest pose of the same frame, with the same meshes in the ghost material.</summary>
    static class ObjectGhost
    {
        /// <summary>Adds a ghost beside a tracked object, and selects it. The user can undo it.</summary>
        public static void AddTo(TrackedObject shown)
        {
            var ghost = Copy(shown.transform, PackageAsset.Ghost.Load<Material>());
            ghost.name = "ghost of " + shown.name;
            var parent = shown.transform.parent;
            CellMenu.Put(ghost, parent == null ? null : parent.gameObject, () =>
            {
                PlaceAs(shown.transform, ghost.transform);
                GameObjectUtility.EnsureUniqueNameForSibling(ghost);
                Follow(ghost.AddComponent<TrackedObject>(), shown);
            });
        }

        // The appearance does not need the session, because it uses that of the object.
        static void Follow(TrackedObject ghost, TrackedObject shown)
        {
            using (var of = new SerializedObject(shown))
            using (var serialised = new SerializedObject(ghost))
            {
                serialised.FindProperty("_session").objectReferenceValue = of.FindProperty("_session").objectReferenceValue;
                serialised.FindProperty("_frame").stringValue = shown.Frame;
                serialised.FindProperty("_shows").intValue = (int)RigPose.Held;
                serialised.ApplyModifiedProperties();
            }
        }

        // Labels are not copied, because they have no mesh asset.
        static GameObject Copy(Transform of, Material material)
        {
            var made = new GameObject(of.name);
            made.SetActive(of.gameObject.activeSelf);
            if (of.TryGetComponent<MeshFilter>(out var filter) && of.TryGetComponent<MeshRenderer>(out var renderer))
            {
                made.AddComponent<MeshFilter>().sharedMesh = filter.sharedMesh;
                made.AddComponent<MeshRenderer>().sharedMaterials = renderer.sharedMaterials.Select(_ => material).ToArray();
            }
            for (var i = 0; i < of.childCount; i++)
            {
                var child = of.GetChild(i);
                if (!IsPartOf(child)) continue;
                var copy = Copy(child, material).transform;
                copy.SetParent(made.transform, worldPositionStays: false);
                PlaceAs(child, copy);
            }
            return made;
        }

        // Other objects and robots below the object have poses and ghosts of their own.
        static bool IsPartOf(Transform child) => child.GetComponentInChildren<MeshFilter>(true) != null
            && !child.TryGetComponent<ICellObject>(out _) && !child.TryGetComponent<RobotRig>(out _) && !child.TryGetComponent<VirtualGripper>(out _);

        static void PlaceAs(Transform of, Transform placed)
        {
            placed.localPosition = of.localPosition;
            placed.localRotation = of.localRotation;
            placed.localScale = of.localScale;
        }
    }
}
