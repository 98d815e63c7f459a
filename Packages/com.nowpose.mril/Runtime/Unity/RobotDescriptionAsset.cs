using Nowpose.Kinematics;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>A robot's URDF as an asset, so that scenes and prefabs can refer to it in every build.</summary>
    [CreateAssetMenu(menuName = "Nowpose/Robot Description", fileName = "Robot")]
    public sealed class RobotDescriptionAsset : ScriptableObject
    {
        // Hidden, because text fields of the Inspector fail at about 16 000 characters, which a URDF may exceed; the asset has its own inspector.
        [SerializeField, HideInInspector]
        string _urdf = "";

        /// <summary>The text of the URDF.</summary>
        public string Urdf => _urdf;

        /// <summary>Creates an asset for a URDF that is known only at run time. <see cref="Read"/> checks it.</summary>
        /// <param name="name">Name in error messages.</param>
        public static RobotDescriptionAsset Create(string name, string urdf)
        {
            var asset = CreateInstance<RobotDescriptionAsset>();
            asset.name = name;
            asset._urdf = urdf;
            return asset;
        }

        /// <exception cref="InputException">Not a robot that can be computed; the message names this asset, the line and the element.</exception>
        public RobotModel Read()
        {
            if (string.IsNullOrWhiteSpace(_urdf)) throw new InputException(RigMessages.NoUrdf(name));
            return UrdfReader.Read(_urdf, "'" + name + "'");
        }
    }
}
