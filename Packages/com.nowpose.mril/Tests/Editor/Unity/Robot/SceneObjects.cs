using System.Collections.Generic;
using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Tests.Unity.Robot
{
    /// <summary>Creates objects for a test in edit mode and destroys them at the end of the test.</summary>
    sealed class SceneObjects
    {
        readonly List<Object> _made = new List<Object>();

        public T Asset<T>(string name) where T : ScriptableObject
        {
            var asset = ScriptableObject.CreateInstance<T>();
            asset.name = name;
            _made.Add(asset);
            return asset;
        }

        public Transform New(string name, Transform parent = null)
        {
            var made = new GameObject(name);
            if (parent == null) _made.Add(made);
            else made.transform.SetParent(parent, false);
            return made.transform;
        }

        public T New<T>(string name, Transform parent = null) where T : Component => New(name, parent).gameObject.AddComponent<T>();

        public Material Material(string name)
        {
            var material = new Material(Shader.Find("Standard")) { name = name };
            _made.Add(material);
            return material;
        }

        /// <summary>
        /// Creates an object for each link, nested in the same way as the links of the robot. Each object is at the position of its parent.
        /// </summary>
        public Dictionary<string, Transform> Links(RobotModel model, Transform rig)
        {
            var links = new Dictionary<string, Transform>();
            foreach (var link in model.Links)
                links.Add(link.Name, New(link.Name, link.ParentJoint == null ? rig : links[link.ParentJoint.ParentLink]));
            return links;
        }

        public void Destroy()
        {
            foreach (var made in _made)
                if (made != null) Object.DestroyImmediate(made);
            _made.Clear();
        }
    }
}
