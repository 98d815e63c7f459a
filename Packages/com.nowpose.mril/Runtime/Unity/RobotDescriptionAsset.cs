using Nowpose.Kinematics;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Asset with the URDF of a robot. Scenes and prefabs can reference it, including in a build.</summary>
    [CreateAssetMenu(menuName = "Nowpose/Robot Description", fileName = "Robot")]
    public sealed class RobotDescriptionAsset : ScriptableObject
    {
        // Hidden in the default Inspector, whose text fields fail above about 16 000 characters. The asset has its own inspector.
        [SerializeField, HideInInspector]
        string _urdf = "";

        /// <summary>The text of the URDF.</summary>
        public string Urdf => _urdf;

        /// <summary>Creates an asset for a URDF that is known only at run time. <see cref="Read"/> checks the URDF.</summary>
        /// <param name="name">Name of the asset in error messages.</param>
        public static RobotDescriptionAsset Create(string name, string urdf)
        {
            var asset = CreateInstance<RobotDescriptionAsset>();
            asset.name = name;
            asset._urdf = urdf;
            return asset;
        }

        /// <summary>Reads the URDF.</summary>
        /// <exception cref="InputException">The URDF is missing or not supported. The message names this asset, the line and the element.</exception>
        public RobotModel Read()
        {
            if (string.IsNullOrWhiteSpace(_urdf)) throw new InputException(RigMessages.NoUrdf(name));
            return UrdfReader.Read(_urdf, "'" + name + "'");
        }
    }
}
