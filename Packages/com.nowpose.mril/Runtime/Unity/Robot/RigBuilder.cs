using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>
    /// Builds the objects of a robot from its description. They are named and nested in the same way as the robot's links, and show its visuals.
    /// </summary>
    /// <remarks>
    /// If none of a link's visuals can be shown, because all of them are meshes whose files are missing, bars from the link to its child joints
    /// represent it.
    /// </remarks>
    static class RigBuilder
    {
        const string Visual = "visual";

        const float BarMetres = 0.03f;

        /// <summary>Builds the robot with all joints at position 0.</summary>
        /// <param name="parent">Transform of the robot's base frame.</param>
        /// <returns>The object of the root link.</returns>
        public static GameObject Build(RobotModel model, Transform parent, IRigLook look)
        {
            var links = new Transform[model.Links.Count];
            var isTool = new bool[links.Length];
            for (var i = 0; i < links.Length; i++)
            {
                var link = model.Links[i];
                links[i] = NewChild(link.Name, i == 0 ? parent : links[link.ParentIndex]);
                if (i > 0) links[i].Place(link.ParentJoint.Origin);
                isTool[i] = i > 0 && (isTool[link.ParentIndex] || model.Links[link.ParentIndex] == model.FlangeLink);
                Show(link, model, links[i], look, isTool[i]);
            }
            return links[0].gameObject;
        }

        static void Show(RobotLink link, RobotModel model, Transform parent, IRigLook look, bool isTool)
        {
            var isShown = false;
            foreach (var visual in link.Visuals)
            {
                var shown = NewVisual(visual, look, isTool);
                if (shown == null) continue;
                isShown = true;
                Add(shown, parent, model);
                shown.Place(visual.Origin);
                shown.localScale = SizeOf(visual);
            }
            if (isShown || link.Visuals.Count == 0) return;
            foreach (var joint in model.Joints)
                if (joint.ParentLink == link.Name)
                    ShowBar(UnityFrame.ToUnity(joint.Origin).Position(), parent, model, look.MaterialOf(null, isTool));
        }

        static Transform NewVisual(LinkVisual visual, IRigLook look, bool isTool)
        {
            if (visual.Shape != VisualShape.Mesh) return NewShape(visual.Shape, look.MaterialOf(visual.Colour, isTool));
            var mesh = look.MeshOf(visual, isTool);
            return mesh == null ? null : mesh.transform;
        }

        static void Add(Transform shown, Transform parent, RobotModel model)
        {
            shown.name = FreeName(parent, model);
            shown.gameObject.layer = parent.gameObject.layer;
            shown.SetParent(parent, worldPositionStays: false);
        }

        // Unity identifies the objects of an imported file by the path of their names, so the name must be unique below the parent. It must also
        // differ from all link names, because the rig finds links by name.
        static string FreeName(Transform parent, RobotModel model)
        {
            for (var i = 1; ; i++)
            {
                var name = i == 1 ? Visual : Visual + " " + i;
                if (parent.Find(name) == null && model.IndexOfLink(name) < 0) return name;
            }
        }

        // Unity's cylinder has its axis along y.
        static void ShowBar(Vector3 end, Transform parent, RobotModel model, Material material)
        {
            if (end == Vector3.zero) return;
            var bar = NewShape(VisualShape.Cylinder, material);
            Add(bar, parent, model);
            bar.PlaceLocally(end / 2, Quaternion.FromToRotation(Vector3.up, end));
            bar.localScale = new Vector3(BarMetres, end.magnitude / 2, BarMetres);
        }

        static Transform NewShape(VisualShape shape, Material material)
        {
            var shown = new GameObject();
            shown.AddComponent<MeshFilter>().sharedMesh = Resources.GetBuiltinResource<Mesh>(MeshOf(shape));
            shown.AddComponent<MeshRenderer>().sharedMaterial = material;
            return shown.transform;
        }

        static Transform NewChild(string name, Transform parent)
        {
            var child = new GameObject(name) { layer = parent.gameObject.layer }.transform;
            child.SetParent(parent, worldPositionStays: false);
            return child;
        }

        // A visual's size is its full extent in URDF axes, or the scale of a mesh. Unity's cylinder is 2 m high; its other shapes measure 1 m.
        static Vector3 SizeOf(LinkVisual visual)
        {
            var (x, y, z) = visual.Size;
            return new Vector3((float)y, (float)(visual.Shape == VisualShape.Cylinder ? z / 2 : z), (float)x);
        }

        static string MeshOf(VisualShape shape)
        {
            switch (shape)
            {
                case VisualShape.Cylinder: return "New-Cylinder.fbx";
                case VisualShape.Sphere: return "New-Sphere.fbx";
                default: return "Cube.fbx";
            }
        }
    }
}
