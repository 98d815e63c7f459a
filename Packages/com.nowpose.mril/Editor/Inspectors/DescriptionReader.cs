using Nowpose.Kinematics;
using Nowpose.Unity;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Reads the robot of a description only when its text has changed, because an inspector is drawn several times per second.</summary>
    sealed class DescriptionReader
    {
        string _urdf;
        RobotModel _model;

        /// <summary>Returns the robot; null if the description is missing or invalid.</summary>
        public RobotModel Of(RobotDescriptionAsset description)
        {
            if (description == null) return null;
            if (description.Urdf == _urdf) return _model;
            _urdf = description.Urdf;
            try
            {
                _model = description.Read();
            }
            catch (InputException)
            {
                _model = null;
            }
            return _model;
        }
    }
}
